#include "view/event_log.hpp"

#include <iostream>

#include "core/types.hpp"
#include "files/utf8_path.hpp"

namespace sunder::view {

using namespace core;

EventLog::EventLog(const std::filesystem::path& path) : path_(path) {
    if (path.empty()) return;
    file_.emplace(path, std::ios::trunc);
    if (!*file_) throw InputError("--log: cannot write '" + files::utf8FromPath(path) + "'");
}

void EventLog::add(const char* name, nlohmann::ordered_json fields) {
    if (!file_) return;
    nlohmann::ordered_json line = {{"event", name}, {"frame", frame_}};
    line.update(fields);
    *file_ << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
    if (*file_) return;
    std::cerr << "sunder: note: --log: '" << files::utf8FromPath(path_)
              << "' cannot be written any more and ends here; is the disk full?\n";
    file_.reset();
}

}  // namespace sunder::view
