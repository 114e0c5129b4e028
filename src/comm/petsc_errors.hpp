// SPDX-License-Identifier: Apache-2.0
// PETSc's error codes as exceptions. During the lifetime of a `PetscErrors`, a failing call of PETSc neither prints nor
// aborts: its first message is stored.
#pragma once
#include <petscsys.h>

#include <stdexcept>
#include <string>

namespace brunt::comm {

struct PetscFailure : std::runtime_error {
  PetscErrorCode code;
  PetscFailure(PetscErrorCode error, const std::string& text) : std::runtime_error(text), code(error) {}
};

class PetscErrors {
 public:
  PetscErrors() { PetscPushErrorHandler(keep, this); }
  ~PetscErrors() { PetscPopErrorHandler(); }
  PetscErrors(const PetscErrors&) = delete;
  PetscErrors& operator=(const PetscErrors&) = delete;

  /// Throws the stored message if `code` is an error.
  void check(PetscErrorCode code) const {
    if (code != 0) throw PetscFailure(code, "PETSc: " + (first_.empty() ? "error " + std::to_string(code) : first_));
  }

 private:
  static PetscErrorCode keep(MPI_Comm /*comm*/, int /*line*/, const char* function, const char* /*file*/,
                             PetscErrorCode code, PetscErrorType kind, const char* message, void* self) {
    const auto& errors = *static_cast<const PetscErrors*>(self);
    if (kind == PETSC_ERROR_INITIAL) errors.first_ = std::string(function) + ": " + message;
    return code;
  }
  mutable std::string first_;
};

}  // namespace brunt::comm
