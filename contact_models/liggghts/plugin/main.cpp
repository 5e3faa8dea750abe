// SPDX-License-Identifier: GPL-2.0-or-later
//
// Program liggghts-plastigran: LIGGGHTS with the laws of libplastigran. Its command line equals
// that of `liggghts`. Differences: a signal stops the run at the end of a step, output is
// line-buffered, and a warning names unknown normal models.
#include <mpi.h>
#include <signal.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "signal_handling.h"

namespace {

struct CommandLine {
  std::string deck;
  // First value of each variable set by -var, with the key "${NAME}".
  std::map<std::string, std::string> values;

  CommandLine(int argc, char** argv) {
    for (int i = 1; i + 1 < argc; ++i) {
      const std::string word = argv[i];
      if (word == "-in" || word == "-i") deck = argv[i + 1];
      if ((word == "-var" || word == "-v") && i + 2 < argc)
        values[std::string("${") + argv[i + 1] + '}'] = argv[i + 2];
    }
  }
};

// Returns a warning for each unknown normal model in a deck, because LIGGGHTS stops without naming
// it.
std::string unknown_models(const CommandLine& command) {
  const std::string known = PLASTIGRAN_MODELS;
  std::ifstream file(command.deck);
  std::string text, earlier, last;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) {
      if (word == "&") continue;
      if (command.values.count(word)) word = command.values.at(word);
      const bool is_model = last == "model" && (earlier == "gran" || earlier == "wall/gran");
      if (is_model && word.find('$') == std::string::npos &&
          (' ' + known + ' ').find(' ' + word + ' ') == std::string::npos)
        text +=
            "WARNING: plastigran: model " + word + " is unknown. Available models: " + known + '\n';
      earlier = last;
      last = word;
    }
  }
  return text;
}

// Configures Open MPI for one rank if no launcher such as mpirun was used. Without this
// configuration, Open MPI would start a daemon and search for networks, which takes as long as the
// start of LIGGGHTS. The session directory is disabled too: without a daemon, all such processes
// would share it, and the first process that ends would delete it.
void start_alone() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name)) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("OMPI_MCA_btl", "self", 0);
}

}  // namespace

int main(int argc, char** argv) {
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = LAMMPS_NS::SignalHandler::int_handler;  // ends the run after this step
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &action, nullptr);

  // Use line buffering: an error on one rank calls MPI_Abort, which discards buffered messages.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  start_alone();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::cerr << unknown_models(CommandLine(argc, argv));
  LAMMPS_NS::LAMMPS* engine = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  engine->input->file();
  // Delete the HistoryKeeper first. Otherwise it would copy the contact histories before LIGGGHTS
  // deletes them.
  char keeper[] = "plastigran_history";
  if (engine->modify->find_fix(keeper) >= 0) engine->modify->delete_fix(keeper);
  delete engine;
  MPI_Finalize();
  return 0;
}
