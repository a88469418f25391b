#!/usr/bin/env python3
"""The spectrum of figure 3's moire, in twenty lines: what the paper's figure shows, measured.

    PYTHONPATH=build/release/python python3 tools/python/figures.py

Run as a script it writes spectrum3.pgm; as a notebook, paste the cells.
"""
# %% Figure 3: the bare shadow, nearest lookup, too little bias.
import numpy as np
import umbra78

frame = umbra78.render(umbra78.Scene.figures(), **umbra78.figure_settings(3))
print(frame.hashes["mask"], f"false shadow {100 * frame.error['false_shadow']:.2f} %")

# %% False shadow on what exact geometry sees lit, in a square on the lower left sphere.
truth = frame.truth()
wrong = (frame["mask"] > 127) & (truth["lit"] == 1) & (truth["visible"] == 1)
window = wrong[384:416, 112:144].astype(float)

# %% Its spectrum, without the mean and what the taper leaks of it. White noise would have 0.56.
power = np.abs(np.fft.fft2((window - window.mean()) * np.outer(*[np.hanning(32)] * 2))) ** 2
f = np.fft.fftfreq(32)
measured = (np.abs(f)[:, None] > 1.5 / 32) | (np.abs(f)[None, :] > 1.5 / 32)
flatness = np.exp(np.log(power[measured]).mean()) / power[measured].mean()
y, x = np.unravel_index(np.argmax(power * measured), power.shape)
print(f"{window.mean():.0%} wrong; flatness {flatness:.3f}; the strongest wave has a period of "
      f"{1 / np.hypot(f[y], f[x]):.1f} pixels")

# %% As a picture, with frequency 0 in its middle.
shown = np.fft.fftshift(np.log1p(power))
with open("spectrum3.pgm", "wb") as file:
    file.write(b"P5 32 32 255\n" + (255 * shown / shown.max()).astype("u1").tobytes())
