#include "sim_gl/drawn_state.hpp"

namespace sunder::sim_gl {

gpu::StateView DrawnState::view() {
    if (gpu::GpuSolver* solver = simulation_.gpuSolver()) return solver->view();
    if (!upload_) upload_ = std::make_unique<gpu::StateUpload>(simulation_.world());
    if (version_ != simulation_.version()) {
        uploaded_ = upload_->upload(simulation_.state());
        version_ = simulation_.version();
    }
    return uploaded_;
}

}  // namespace sunder::sim_gl
