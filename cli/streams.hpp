#pragma once

namespace tripus::cli {

/// To be called first of all: where standard input, output or error is closed, opens the null
/// device in its place, so that no file that is opened later takes its number and gets our
/// messages. The device is opened for the other direction: reading nothing and writing to nowhere
/// are errors that are told, not done in silence. A file that grows beyond a limit gives an error
/// like a full disk instead of a signal.
void secure_standard_streams();

/// OpenBLAS starts a thread a core when it is loaded, each with its share of the address space, and
/// waits for ever at the end for those that did not come up. Matrices here are small: one thread,
/// unless the user's OPENBLAS_NUM_THREADS says otherwise. Where the address space is limited the
/// program begins anew with that said before the library is loaded.
void limit_blas_threads(char** argv);

}  // namespace tripus::cli
