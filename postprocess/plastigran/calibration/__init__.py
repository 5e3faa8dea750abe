# SPDX-License-Identifier: GPL-2.0-or-later
"""From what people can measure of a metal to what the laws take."""
