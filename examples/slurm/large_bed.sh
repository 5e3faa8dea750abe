#!/bin/bash
# Runs your own deck on many nodes with Slurm, in several jobs. Each job continues from a complete
# checkpoint.
#
#   sbatch examples/slurm/large_bed.sh bed.in
#   sbatch --dependency=afterany:JOBID examples/slurm/large_bed.sh bed.in     # next job
#
# The deck reads the restart file in the variable `checkpoint`, and writes two restart files in turn:
#
#   variable checkpoint index none
#   if "${checkpoint} == none" then "read_data bed.data" else "read_restart ${checkpoint}"
#   restart 100000 bed.0.restart bed.1.restart
#   run 10000000 upto
#
#SBATCH --job-name=bed
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=60
#SBATCH --cpus-per-task=1
#SBATCH --exclusive
#SBATCH --time=24:00:00
#SBATCH --output=bed_%j.log
set -euo pipefail

deck=${1:?"usage: sbatch large_bed.sh DECK"}
engine=${PLASTIGRAN_ENGINE:-liggghts-plastigran}
export OMP_NUM_THREADS=1

# Use the older of the two files, because the end of a job may have truncated the newer one, which
# LIGGGHTS would not notice. If there is only one file, start again.
checkpoint=$(ls -t bed.0.restart bed.1.restart 2>/dev/null | sed -n 2p || true)
checkpoint=${checkpoint:-none}
echo "starting from checkpoint $checkpoint on $SLURM_NNODES nodes, $SLURM_NTASKS ranks"

# Use one rank per core. Ranks that are neighbors in space are on the same node.
srun --mpi=pmix --cpu-bind=cores --distribution=block:block \
  "$engine" -in "$deck" -log "bed_$SLURM_JOB_ID.liggghts" -var checkpoint "$checkpoint"
