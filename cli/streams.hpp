#pragma once

namespace tripus::cli {

/// To be called first of all: where standard input, output or error is closed, opens the null
/// device in its place, so that no file that is opened later takes its number and gets our
/// messages. The device is opened for the other direction: reading nothing and writing to nowhere
/// are errors that are told, not done in silence. A file that grows beyond a limit gives an error
/// like a full disk instead of a signal.
void secure_standard_streams();

/// What libraries would do by themselves. Where the address space is limited, threads share one
/// heap. OpenBLAS works with one thread, since matrices here are small, unless the user's
/// OPENBLAS_NUM_THREADS says otherwise. Mesa keeps no shaders on the disk: the thread that does it
/// has the least priority, so that on a busy machine the process could not end for seconds.
void tame_libraries();

}  // namespace tripus::cli
