# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# Shared by the scripts: location and build of the project, environment of MPI. Sourced, never run.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export BRUNT="${BRUNT:-$project/build/release/brunt}"  # the program that run, demo and study start

# fail CODE MESSAGE: prints the message and ends the script with this code (2 wrong input, 4 failure of the machine).
fail() {
  local code=$1
  shift
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit "$code"
}

# excerpt TEXT: what a message quotes of it: one line of at most 60 characters, as of the program.
excerpt() {
  local text=${1//[[:space:]]/ }
  [ "${#text}" -le 60 ] && printf '%s' "$text" || printf '%s...' "${text:0:60}"
}

# comment_block FILE: the comment at the top of a script is its help.
comment_block() {
  awk 'NR > 2 { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$1"
}

# configure PRESET: runs CMake.
configure() {
  (cd "$project" && cmake --preset "$1" >&2) || fail 4 "cmake failed (see above)"
}

# build PRESET [cmake --build options]: configures and builds with all cores.
build() {
  local preset=$1
  shift
  configure "$preset"
  (cd "$project" && cmake --build --preset "$preset" --parallel "$(nproc)" "$@" >&2) ||
    fail 4 "the build failed (see above)"
}

# mpi_environment RANKS: exports settings of Open MPI for RANKS ranks; settings of the user are kept.
mpi_environment() {
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  # Ranks are never bound to cores: two jobs of one rank would otherwise share core 0.
  export OMPI_MCA_hwloc_base_binding_policy="${OMPI_MCA_hwloc_base_binding_policy:-none}"
  export OMPI_MCA_rmaps_base_oversubscribe=1
  # Where mpirun ends the ranks itself, it waits this long [s] (twice) between SIGTERM and SIGKILL, needed or not: enough
  # to save a middling model. scripts/run stops runs in another way, without this limit; but scancel sends SIGTERM to mpirun
  # too, and Slurm's own SIGKILL comes after 30 s (KillWait).
  local patience=5
  [ -z "${SLURM_JOB_ID:-}" ] || patience=12
  export OMPI_MCA_odls_base_sigkill_timeout="${OMPI_MCA_odls_base_sigkill_timeout:-$patience}"
  # Within one node: shared memory alone starts faster, and copying through it beats the kernel's copy.
  if [ "${SLURM_JOB_NUM_NODES:-1}" -eq 1 ] && [ -z "${OMPI_MCA_orte_default_hostfile:-}" ]; then
    export OMPI_MCA_pml="${OMPI_MCA_pml:-ob1}" OMPI_MCA_btl="${OMPI_MCA_btl:-self,vader}"
    export OMPI_MCA_btl_vader_single_copy_mechanism="${OMPI_MCA_btl_vader_single_copy_mechanism:-none}"
    # waiting ranks yield: without cost if each has a core, and necessary if cores are shared
    if [ "$1" -ge "$(nproc)" ]; then
      export OMPI_MCA_mpi_yield_when_idle="${OMPI_MCA_mpi_yield_when_idle:-1}"
    fi
  fi
}
