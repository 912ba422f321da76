// A scene from a text file: a body a line (contact --help says how).
#pragma once
#include "ch13-contact/scene.h"

// The scene of the file of this name, or of standard input for "-",
// complete, with at least one body. Names of meshes in it are seen from
// the folder of the file. Fails with the name of the file, the line,
// and what was found there.
struct scene read_scene(const char *name);
