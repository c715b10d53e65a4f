# SPDX-License-Identifier: Apache-2.0
"""Builders of the project's own scenes (see scenes/README.md)."""
