/**
 * A scene made ready for rendering: {@link enlightenment.world.SceneCompiler} runs passes, each of which makes one part from the
 * parts before it, and {@link enlightenment.world.Tracer} asks the result what a ray meets. What a ray is worth is decided in
 * {@code transport}.
 */
package enlightenment.world;
