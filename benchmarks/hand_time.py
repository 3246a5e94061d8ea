# SPDX-License-Identifier: GPL-3.0-or-later
"""hand_time.py <sinew> <scratch folder>: model,processor seconds of `sinew generate` for each model."""
import pathlib
import sys

from chain_growth import processor_seconds

sinew, place = sys.argv[1], pathlib.Path(sys.argv[2])
for model in ("index", "middle", "ring", "fifth", "thumb", "wrist", "hand"):
    command = [sinew, "generate", f"models/{model}", "--out", str(place / model)]
    print(f"{model},{min(processor_seconds(command) for _ in range(3)):.3f}")
