// SPDX-License-Identifier: GPL-2.0-or-later
//
// liggghts-plastigran: stock LIGGGHTS with the contact laws of libplastigran loaded. Same command
// line as `liggghts`; one check more: a `-var` the deck never mentions is a misspelling, not a
// no-op.
#include <mpi.h>
#include <signal.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Whether a deck uses a variable it does not declare: ${name}, $n or v_name.
bool mentions(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool ends = end == text.size() || !is_word(text[end]);
    const std::string before = text.substr(at < 2 ? 0 : at - 2, at < 2 ? at : 2);
    if (ends && (before == "${" || before == "v_" || (name.size() == 1 && before.back() == '$')))
      return true;
  }
  return false;
}

// A deck with the files it includes: its text and what it lets one set (`variable NAME index ...`).
struct Deck {
  std::string text;
  std::vector<std::string> settings;
  std::map<std::string, std::string> values;  // of the settings so far: to resolve include paths
  bool complete = true;                       // false when a file it reads could not be followed

  void read(const std::string& path) {
    std::ifstream file(path);
    complete = complete && file;
    for (std::string line; std::getline(file, line);) {
      line = substitute(line.substr(0, line.find('#')));
      text += line + '\n';
      std::istringstream words(line);
      std::string command, name, style, value;
      words >> command >> name >> style >> value;
      if (command == "variable" || command == "next") declared.insert(name);
      if (command == "variable" && style == "index") {
        settings.push_back(name);
        values.emplace(name, value);  // one given on the command line stays
      } else if (command == "include") {
        read(name);
      } else if (command == "jump" && name != "SELF") {
        complete = false;
      }
    }
  }

  // The line with its known ${name} replaced; the rest is the engine's business.
  std::string substitute(std::string line) {
    for (const auto& [name, value] : values) {
      const std::string reference = "${" + name + "}";
      if (value.find(reference) != std::string::npos) continue;
      for (std::size_t at; (at = line.find(reference)) != std::string::npos;) {
        used.insert(name);
        line.replace(at, reference.size(), value);
      }
    }
    return line;
  }

  std::set<std::string> used, declared;
};

// The complaint about a -var the deck does not know, or an empty string.
std::string check_command_line(int argc, char** argv) {
  std::string path;
  Deck deck;
  std::vector<std::string> given;
  for (int i = 1; i + 1 < argc; ++i) {
    if (!std::strcmp(argv[i], "-in") || !std::strcmp(argv[i], "-i"))
      path = argv[++i];
    else if ((!std::strcmp(argv[i], "-var") || !std::strcmp(argv[i], "-v")) && i + 2 < argc) {
      given.push_back(argv[i + 1]);
      deck.values[argv[i + 1]] = argv[i + 2];
      i += 2;
    }
  }
  if (path.empty() || given.empty()) return {};
  deck.read(path);
  for (const std::string& name : given) {
    if (deck.declared.count(name) || deck.used.count(name) || mentions(deck.text, name)) continue;
    if (!deck.complete) continue;  // the engine says what it cannot read
    std::string message = "-var " + name + ": " + path + " has no such variable";
    if (!deck.settings.empty()) message += "; it takes";
    for (const std::string& setting : deck.settings) message += " " + setting;
    return message;
  }
  return {};
}

// Open MPI starts a daemon for a process that no launcher started, and looks for ways to reach
// others. A rank alone needs neither; together they take as long as the engine's own start. Without
// a daemon all such processes have one session directory, which one that ends takes from another
// that begins; a rank alone has nothing to keep there.
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
  action.sa_handler = LAMMPS_NS::SignalHandler::int_handler;  // finish the step, write what is due
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &action, nullptr);

  // One rank's error ends in MPI_Abort, which would take the buffered message with it.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  start_alone();
  MPI_Init(&argc, &argv);
  const std::string complaint = check_command_line(argc, argv);
  if (!complaint.empty()) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) std::cerr << "ERROR: " << complaint << std::endl;
    MPI_Finalize();
    return 1;
  }
  LAMMPS_NS::LAMMPS* engine = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  engine->input->file();
  delete engine;
  MPI_Finalize();
  return 0;
}
