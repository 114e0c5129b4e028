// SPDX-License-Identifier: Apache-2.0
#include "one_thread.hpp"

#include <dlfcn.h>

namespace brunt::comm {

void keep_blas_on_one_thread() {
  // the BLAS is determined when the program starts, not when it is linked
  using SetThreads = void (*)(int);
  for (const char* name : {"openblas_set_num_threads", "MKL_Set_Num_Threads", "omp_set_num_threads"})
    if (void* found = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<SetThreads>(found)(1);
  using SetManyThreads = void (*)(long);
  if (void* found = dlsym(RTLD_DEFAULT, "bli_thread_set_num_threads")) reinterpret_cast<SetManyThreads>(found)(1);
}

}  // namespace brunt::comm
