/**
 * Makes pictures of scenes, in one process. {@link enlightenment.render.Renderer} is the way in:
 *
 * <pre>{@code
 * Image image = Renderer.render(scene);
 * }</pre>
 *
 * <p>or, to hear how it gets on, to stop it, and to have more than the picture:
 *
 * <pre>{@code
 * RenderResult result = Renderer.render(RenderRequest.of(scene)
 *         .withSettings(settings)
 *         .withProgress(listener)
 *         .withCancelled(stop::get)
 *         .withAuxiliary(RenderResult.Auxiliary.DEPTH, RenderResult.Auxiliary.NORMAL));
 * }</pre>
 */
package enlightenment.render;
