/* How the names of Sunder's library get out of it. Nothing in here is for callers. */
#ifndef SUNDER_EXPORT_H
#define SUNDER_EXPORT_H

/* SUNDER_SHARED: defined for who uses a shared library of Sunder, by its CMake and pkg-config
   files. SUNDER_BUILDING: while that library is compiled. */
#if defined(_WIN32) && defined(SUNDER_SHARED)
#ifdef SUNDER_BUILDING
#define SUNDER_API __declspec(dllexport)
#else
#define SUNDER_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define SUNDER_API __attribute__((visibility("default")))
#else
#define SUNDER_API
#endif

#endif
