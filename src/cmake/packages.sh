# The Debian packages that carom is built from, and how to get the missing ones. Sourced by tests/run.sh and examples/quickstart.sh.

build_packages=(g++ cmake ninja-build
  libboost-dev libeigen3-dev libgsl-dev libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev
  libmpfr-dev libgmp-dev libmpfi-dev
  libhdf5-dev)  # optional: H5MD files
test_packages=(libgtest-dev libgmock-dev librapidcheck-dev
  libbox2d-dev libchipmunk-dev libbullet-dev  # `carom compare` sets these beside carom
  gnuplot-nox  # draws for `carom plot`
  python3-h5py python3-ase)  # read what carom has written

build_packages+=(libopenmpi-dev openmpi-bin)  # carom sweep under mpirun
build_packages+=(libcpp-httplib-dev pkg-config)  # carom run --live
# The page of `carom view` is bundled by node and npm and tested in chromium: from Debian unless they are there already.
if ! command -v node > /dev/null || ! command -v npm > /dev/null; then build_packages+=(nodejs npm); fi
if ! command -v chromium > /dev/null; then test_packages+=(chromium); fi

# need_packages PACKAGE...: installs what is missing. Fails, naming it, where that is not allowed.
need_packages() {
  if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
    echo "carom: no apt here, so nothing is installed. These Debian packages are needed, by whatever name: $*" >&2
    return 0
  fi

  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2> /dev/null | grep -x installed > /dev/null || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then return 0; fi

  local as_root=()
  if ((EUID != 0)); then
    if ! sudo -n true 2> /dev/null; then
      echo "carom: packages are missing, and only root may install them. Please run:" >&2
      echo "  sudo apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo -n)
  fi

  echo "carom: installing ${missing[*]}" >&2
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update < /dev/null || echo "carom: apt-get update complained (above); going on with what it has" >&2
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" < /dev/null > /dev/null
}
