// SPDX-License-Identifier: GPL-2.0-or-later
// Library that counts the MPI calls of LIGGGHTS if it is preloaded (LD_PRELOAD). It writes a file
// mpi_calls.<rank> in the working folder of LIGGGHTS. The file has a line for each kind of MPI
// call: number of calls, and bytes sent or reduced.
#include <mpi.h>
#include <stdio.h>

enum { SEND, SENDRECV, ALLREDUCE, REDUCE, BCAST, GATHER, BARRIER, SCAN, KINDS };
static const char* const names[KINDS] = {"send",  "sendrecv", "allreduce", "reduce",
                                         "bcast", "gather",   "barrier",   "scan"};
static long calls[KINDS], bytes[KINDS];

static void note(int kind, int count, MPI_Datatype type) {
  int size;
  PMPI_Type_size(type, &size);
  ++calls[kind];
  bytes[kind] += (long)count * size;
}

int MPI_Send(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  note(SEND, n, type);
  return PMPI_Send(data, n, type, to, tag, comm);
}
int MPI_Isend(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request) {
  note(SEND, n, type);
  return PMPI_Isend(data, n, type, to, tag, comm, request);
}
int MPI_Sendrecv(const void* data, int n, MPI_Datatype type, int to, int tag, void* in, int m,
                 MPI_Datatype type_in, int from, int tag_in, MPI_Comm comm, MPI_Status* status) {
  note(SENDRECV, n, type);
  return PMPI_Sendrecv(data, n, type, to, tag, in, m, type_in, from, tag_in, comm, status);
}
int MPI_Allreduce(const void* data, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  note(ALLREDUCE, n, type);
  return PMPI_Allreduce(data, out, n, type, op, comm);
}
int MPI_Reduce(const void* data, void* out, int n, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm) {
  note(REDUCE, n, type);
  return PMPI_Reduce(data, out, n, type, op, root, comm);
}
int MPI_Bcast(void* data, int n, MPI_Datatype type, int root, MPI_Comm comm) {
  note(BCAST, n, type);
  return PMPI_Bcast(data, n, type, root, comm);
}
int MPI_Allgather(const void* data, int n, MPI_Datatype type, void* out, int m, MPI_Datatype to,
                  MPI_Comm comm) {
  note(GATHER, n, type);
  return PMPI_Allgather(data, n, type, out, m, to, comm);
}
int MPI_Barrier(MPI_Comm comm) {
  ++calls[BARRIER];
  return PMPI_Barrier(comm);
}
int MPI_Scan(const void* data, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  note(SCAN, n, type);
  return PMPI_Scan(data, out, n, type, op, comm);
}

int MPI_Finalize(void) {
  char name[32];
  int rank;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  snprintf(name, sizeof name, "mpi_calls.%d", rank);
  FILE* const file = fopen(name, "w");
  for (int kind = 0; file && kind < KINDS; ++kind)
    fprintf(file, "%s %ld %ld\n", names[kind], calls[kind], bytes[kind]);
  if (file) fclose(file);
  return PMPI_Finalize();
}
