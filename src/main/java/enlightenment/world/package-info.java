/**
 * Scenes compiled for rendering: {@link enlightenment.world.SceneCompiler} runs passes, each of which makes one part from the parts before
 * it, and {@link enlightenment.world.Tracer} traces rays through the result. Light transport is in {@code transport}.
 */
package enlightenment.world;
