"""Prompts: the face of the packet sandbox."""
