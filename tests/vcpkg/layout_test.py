#!/usr/bin/env python3
"""Whether the preset `vcpkg` fits what vcpkg installs, as far as that can be seen without vcpkg.

Stub packages lie where vcpkg's ports put theirs, of each its targets and the headers a user may include. Nothing else is to be
found, as on Windows. The preset must configure, and every header that is included in angle brackets, by a source or by what it
includes of ours, must be a system's or lie in a folder that the source is compiled with.
"""
import json
import os
from pathlib import Path
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = Path(__file__).resolve().parents[2]

# Package as CMake calls it: folder below share/, targets, folder of headers, headers.
PACKAGES = {
    'CLI11': ('cli11', ['CLI11::CLI11'], 'include', ['CLI/CLI.hpp']),
    'Catch2': ('catch2', ['Catch2::Catch2'], 'include', ['catch2/catch_all.hpp', 'catch2/catch_session.hpp']),
    'Eigen3': ('eigen3', ['Eigen3::Eigen'], 'include/eigen3',
               ['Eigen/' + name for name in ('Core', 'Dense', 'Eigenvalues', 'Geometry', 'LU', 'QR', 'SVD')]),
    'TBB': ('tbb', ['TBB::tbb'], 'include', ['tbb/global_control.h', 'tbb/parallel_for.h', 'tbb/task_arena.h', 'tbb/task_group.h']),
    'glfw3': ('glfw3', ['glfw'], 'include', ['GLFW/glfw3.h']),
    'glm': ('glm', ['glm::glm'], 'include',
            ['glm/geometric.hpp', 'glm/glm.hpp', 'glm/mat3x3.hpp', 'glm/vec3.hpp', 'glm/vec4.hpp', 'glm/gtc/matrix_inverse.hpp',
             'glm/gtc/matrix_transform.hpp', 'glm/gtc/type_ptr.hpp']),
    'hwy': ('hwy', ['hwy::hwy'], 'include', ['hwy/base.h', 'hwy/foreach_target.h', 'hwy/highway.h']),
    'imgui': ('imgui', ['imgui::imgui'], 'include',
              ['imgui.h', 'imgui_impl_glfw.h', 'imgui_impl_opengl3.h', 'imgui_stdlib.h']),
    'nlohmann_json': ('nlohmann_json', ['nlohmann_json::nlohmann_json'], 'include', ['nlohmann/json.hpp']),
    'tomlplusplus': ('tomlplusplus', ['tomlplusplus::tomlplusplus'], 'include', ['toml++/toml.h']),
}
# No package for CMake: found by its headers.
STB = ['stb_easy_font.h', 'stb_image.h', 'stb_image_write.h']

# Of operating systems and compilers. C++'s own have neither a dot nor a folder.
SYSTEM = re.compile(r'\w+|sys/\w+\.h|(fcntl|io|malloc|poll|shellapi|spawn|stddef|stdint|unistd|windows|xmmintrin)\.h')
# Looked for with __has_include: Catch2 2 has it, vcpkg has 3.
OPTIONAL = {'catch2/catch.hpp'}
# No file of Windows.
ELSEWHERE = {'src/window/egl_context.cpp'}


def install_stubs(vcpkg):
    installed = vcpkg / 'installed'

    def write(path, text=''):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    for name, (folder, targets, include, headers) in PACKAGES.items():
        write(installed / 'share' / folder / f'{name}Config.cmake', ''.join(
            f'add_library({target} INTERFACE IMPORTED)\n'
            f'target_include_directories({target} INTERFACE {installed / include})\n' for target in targets))
        write(installed / 'share' / folder / f'{name}ConfigVersion.cmake',
              'set(PACKAGE_VERSION 99)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n')
        for header in headers:
            write(installed / include / header)
    for header in STB:
        write(installed / 'include' / header)
    write(installed / 'share/catch2/Catch.cmake', 'function(catch_discover_tests)\nendfunction()\n')
    with open(installed / 'share/catch2/Catch2Config.cmake', 'a', encoding='utf-8') as config:
        config.write('list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})\n')
    write(vcpkg / 'scripts/buildsystems/vcpkg.cmake', f'set(CMAKE_FIND_ROOT_PATH {installed})\n' + ''.join(
        f'set(CMAKE_FIND_ROOT_PATH_MODE_{kind} ONLY)\n' for kind in ('PACKAGE', 'INCLUDE', 'LIBRARY')))


def configure(folder):
    environment = dict(os.environ, VCPKG_ROOT=str(folder / 'vcpkg'))
    # What Windows and macOS have instead of EGL.
    return subprocess.run(
        ['cmake', '--preset', 'vcpkg', '-B', str(folder / 'build'), '-DSUNDER_CONTEXT=glfw', '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'],
        cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


def includes_of(file, cache={}):
    """Pairs of bracket and name."""
    if file not in cache:
        text = file.read_text(encoding='utf-8')
        cache[file] = re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', text, re.MULTILINE)
    return cache[file]


def unresolved(source, folders):
    """Headers in angle brackets that are neither a system's nor in one of the folders."""
    missing, seen, todo = set(), set(), [source]
    while todo:
        file = todo.pop()
        if file in seen:
            continue
        seen.add(file)
        for bracket, name in includes_of(file):
            if bracket == '<':
                if not SYSTEM.fullmatch(name) and name not in OPTIONAL and not any((f / name).is_file() for f in folders):
                    missing.add(f'<{name}> of {file.relative_to(ROOT)}')
            else:
                todo += [place for place in (f / name for f in [file.parent, *folders]) if place.is_file()][:1]
    return missing


class VcpkgLayout(unittest.TestCase):
    def test_the_preset_configures_and_every_include_is_there(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            install_stubs(folder / 'vcpkg')
            configured = configure(folder)
            self.assertEqual(configured.returncode, 0, configured.stdout)
            # Generated by a build; its own headers are not what is asked here.
            glad = folder / 'build/glad/include/glad/gl.h'
            glad.parent.mkdir(parents=True)
            glad.touch()
            glad.with_name('calls.h').touch()
            compiled = set()
            missing = set()
            for command in json.loads((folder / 'build/compile_commands.json').read_text()):
                source = Path(command['file'])
                if ROOT not in source.parents or not source.is_file():
                    continue
                compiled.add(source)
                folders = [Path(f) for f in re.findall(r'(?:-I|-isystem )(\S+)', command['command'])]
                missing |= unresolved(source, folders)
            self.assertEqual(missing, set())
            # What another system compiles instead is not in that list.
            ours = {file for top in ('src', 'tests') for file in (ROOT / top).rglob('*.cpp')}
            for file in sorted(ours - compiled):
                if str(file.relative_to(ROOT)) in ELSEWHERE:
                    continue
                everywhere = [ROOT / 'src', ROOT / 'tests', folder / 'vcpkg/installed/include',
                              folder / 'vcpkg/installed/include/eigen3', glad.parents[1]]
                self.assertEqual(unresolved(file, everywhere), set())


if __name__ == '__main__':
    sys.exit(unittest.main())
