package enlightenment.transport.ray;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import java.util.function.BooleanSupplier;

/**
 * Computes the colour or radiance along one camera ray. A method decides which rays are followed and how their colours become pixels; a
 * shader depends on no pixel. The result is a pure function of the ray and the sampler's numbers. One per thread.
 */
public interface Shader {
    /**
     * Sets the tile of the camera rays to come, so that primitives outside of its view are skipped: (x0..x1, y0..y1), 0..1 from the
     * picture's upper left corner.
     */
    void beginTile(double x0, double y0, double x1, double y1);

    /** Whether all camera rays of the tile are known to leave the scene. */
    boolean seesNothing();

    /**
     * Sets the condition of cancellation: once it holds, {@link #shade} soon throws a {@link java.util.concurrent.CancellationException},
     * however long the path is.
     */
    void stopWhen(BooleanSupplier condition);

    /**
     * Estimates what is seen along a camera ray: display-referred colour for classic shading; for physical shading one unbiased sample of
     * the incident radiance, or of the part of it that the shader is made for (linear, W/(m² sr), relative; with dispersion components
     * may be negative).
     *
     * @param ray the camera ray in the frame, within the tile; overwritten
     * @param sampler set to the pixel and the sample; its numbers are all the randomness
     * @param out receives red, green and blue
     * @throws java.util.concurrent.CancellationException once the condition of {@link #stopWhen} holds
     */
    void shade(Ray ray, Sampler sampler, double[] out);
}
