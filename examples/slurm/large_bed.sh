#!/bin/bash
# A deck of one's own on many nodes with Slurm, in parts: each job goes on from a whole checkpoint.
#
#   sbatch examples/slurm/large_bed.sh bed.in
#   sbatch --dependency=afterany:JOBID examples/slurm/large_bed.sh bed.in     # and once more
#
# The deck takes its start from the variable `checkpoint` and writes two files in turn:
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

# The older of the two: the end of a job may have cut the newer one short, which the engine would not
# notice. One alone is not trusted.
checkpoint=$(ls -t bed.0.restart bed.1.restart 2>/dev/null | sed -n 2p || true)
checkpoint=${checkpoint:-none}
echo "from $checkpoint on $SLURM_NNODES nodes, $SLURM_NTASKS ranks"

# One rank a core, neighbours in space on the same node.
srun --mpi=pmix --cpu-bind=cores --distribution=block:block \
  "$engine" -in "$deck" -log "bed_$SLURM_JOB_ID.liggghts" -var checkpoint "$checkpoint"
