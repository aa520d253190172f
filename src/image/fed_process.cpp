#include "image/fed_process.hpp"

namespace sunder::image {

std::string FedProcess::complaints() const {
    std::string text;
    if (!errors_) return text;
    std::rewind(errors_);
    for (int c = std::fgetc(errors_); c != EOF; c = std::fgetc(errors_))
        text += static_cast<char>(c);
    return text;
}

}  // namespace sunder::image
