#include "sim_gl/drawn_state.hpp"

namespace sunder::sim_gl {

gpu::StateView DrawnState::view() {
    if (gpu::GpuSolver* solver = simulation_.gpuSolver()) return solver->view();
    if (!upload_) upload_ = std::make_unique<gpu::StateUpload>(simulation_.world());
    return upload_->upload(simulation_.state());
}

}  // namespace sunder::sim_gl
