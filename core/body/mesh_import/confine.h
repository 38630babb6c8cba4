#pragma once

namespace toile::mesh_import {

/// Gives up all that reading bytes from standard input and writing to standard output does not need: other
/// files, processes, networks, and the rights of root where this process has them. What is asked of the
/// kernel beyond that fails (EPERM). For good; what the kernel does not grant is no reason to stop. Linux.
void confine();

}  // namespace toile::mesh_import
