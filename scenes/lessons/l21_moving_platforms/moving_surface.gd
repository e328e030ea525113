class_name MovingSurface
extends RefCounted
## What the lesson on surfaces that move has of them, and the ball that they meet.

## What moves.
enum Kind { WALL, BELT, PLATFORM, PADDLE, PRESS }

## The ball's radius, in pixels.
const RADIUS := 20.0
