#pragma once
#include <cstdlib>

/// On Linux and macOS: the program, and ffprobe, which is packaged with it.
inline bool ffmpegIsThere() {
    return std::system("ffmpeg -version > /dev/null 2>&1 && ffprobe -version > /dev/null 2>&1") ==
           0;
}
