// Stands in for ffmpeg where tests ask only for what it is told: writes its input to the file of
// its last argument.
#include <cstdio>
#include <fstream>
#include <string>

#include "files/system.hpp"
#include "files/utf8_path.hpp"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

int main(int argc, char** argv) {
#ifdef _WIN32
    _setmode(_fileno(stdin), _O_BINARY);
#endif
    const std::string protocol = "file:", target = sunder::files::commandLine(argc, argv).back();
    if (!target.starts_with(protocol)) return 1;
    std::ofstream file(sunder::files::pathFromUtf8(target.substr(protocol.size())),
                       std::ios::binary);
    char bytes[4096];
    while (const std::size_t count = std::fread(bytes, 1, sizeof bytes, stdin))
        file.write(bytes, static_cast<std::streamsize>(count));
    return file ? 0 : 1;
}
