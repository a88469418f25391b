"""The machine's stages, a module a section or two of hw/MACHINE.md, written from its text."""
