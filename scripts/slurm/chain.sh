# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# What jobs share that go on over the time limit of a job: chain.sbatch and array.sbatch. Sourced, never run.

# shellcheck source=scripts/lib/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../lib/common.sh"

newest_checkpoint() { # FOLDER; nothing where there is none
  [ ! -d "$1" ] || find "$1" -maxdepth 1 -name 'checkpoint_*.h5' | sort | tail -n 1
}

# requeue BEFORE AFTER: the newest checkpoints before and after this turn; a chain that gains nothing ends.
requeue() {
  [ "$1" != "$2" ] || fail 5 "no step was gained within this time limit; expected a longer --time"
  echo "chain: stopped before the time limit at ${2##*/}; job $SLURM_JOB_ID goes back into the queue"
  scontrol requeue "$SLURM_JOB_ID" || fail 5 "Slurm does not take job $SLURM_JOB_ID back; to go on: submit it again"
}

# run_or_go_on SCENE FOLDER [options of brunt run]: starts the run, or continues it from the last checkpoint in FOLDER. Before
# the time limit (SIGUSR2) the run stops with a checkpoint and the job is requeued; otherwise brunt's exit code is returned. scancel
# (SIGTERM) reaches the ranks without this script, which then only must not requeue.
run_or_go_on() {
  local scene=$1 folder=$2 before code=0 pid
  shift 2
  before=$(newest_checkpoint "$folder")
  if [ -n "$before" ]; then
    set -- "$@" --restart "$folder"
  elif [ "${SLURM_RESTART_COUNT:-0}" -gt 0 ]; then
    set -- "$@" --force # an earlier start of this job ended without a checkpoint
  fi

  local request=none interrupted=yes
  "$project/scripts/run" -np "$SLURM_NTASKS" "$scene" --out "$folder" "$@" &
  pid=$!
  trap 'interrupted=yes; [ $request = cancel ] || request=time; kill -USR2 "$pid" 2>/dev/null || true' USR2
  trap 'interrupted=yes request=cancel' TERM
  while [ "$interrupted" = yes ]; do # wait also returns when a signal came in
    interrupted=no code=0
    wait "$pid" || code=$?
  done
  if [ "$code" -eq 5 ] && [ "$request" = time ]; then
    requeue "$before" "$(newest_checkpoint "$folder")"
    return 0
  fi
  return "$code"
}
