@tool
extends EditorPlugin
## The stand-in has no panel in the editor; plugin.cfg must name a script.
