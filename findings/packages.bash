# Pinned packages in a temporary folder; sourced by the findings in this folder.
# shellcheck shell=bash

cannot_run() {
  echo "${0##*/}: $1" >&2
  exit 2
}

# Makes a temporary folder, goes there, and removes it at the end. $folder is its name.
enter_temporary_folder() {
  local program
  for program in apt-get dpkg g++; do
    [[ $(type -t "$program") ]] || cannot_run "$program is missing"
  done
  folder=$(mktemp -d)
  trap 'rm -r "$folder"' EXIT
  cd "$folder"
}

# Downloads packages, given as NAME or NAME=VERSION, and unpacks them here.
unpack_packages() {
  local package
  apt-get download -qq -o APT::Sandbox::User=root "$@" > log 2>&1 ||
    cannot_run "a package cannot be downloaded: $(tail -n 1 log)"
  for package in *.deb; do
    dpkg -x "$package" .
  done
}
