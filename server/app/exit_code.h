#pragma once

namespace toile::app {

/// What the program says by its exit code. `toile --help` lists them.
enum ExitCode : int {
  kDone = 0,       ///< done; a drape has settled
  kInternal = 1,   ///< a fault of the program or of the machine
  kBadInput = 2,   ///< wrong arguments, or a document or file that cannot be used
  kUnsettled = 3,  ///< the drape ended before the cloth came to rest; its results are written
  kCancelled = 4,  ///< interrupted from outside
  kNotWorn = 5,    ///< the cloth came to rest, but the body does not wear it; its results are written
  kNotSame = 6,    ///< verify: inputs, results or a second drape are not what the manifest says
};

}  // namespace toile::app
