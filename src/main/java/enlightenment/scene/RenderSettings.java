package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.sampling.Distribution;
import java.util.Objects;
import java.util.Optional;

/**
 * Everything beside the scene that a render depends on, or, where it says so, only how the render is carried out.
 *
 * @param method which samples are taken: {@code "raytrace"} or {@code "cluster"}
 * @param width width of the whole picture in pixels
 * @param height height of the whole picture in pixels
 * @param crop the part to render; its pixels are the same as in the whole picture
 * @param antialias n for n × n positions per pixel
 * @param shadowSamples light points per hit and light
 * @param seed what all random numbers are derived from
 * @param budget what ends the render, if not the number of positions
 * @param proposal the family of distributions that ray clusters propose light points from: {@code "normal"}, {@code "zeta"} or
 *     {@code "linear"}
 * @param threads how many threads share the work, at least 1; has no influence on the picture
 * @param tileSize side of the square tiles that the work is cut into; has no influence on the picture
 */
public record RenderSettings(
        String method,
        int width,
        int height,
        Optional<Crop> crop,
        int antialias,
        int shadowSamples,
        long seed,
        Budget budget,
        String proposal,
        int threads,
        int tileSize) {
    private static final int DEFAULT_TILE_SIZE = 8;

    /**
     * A part of the picture.
     *
     * @param x first column
     * @param y first row, counted from the top
     * @param width number of columns, at least 1
     * @param height number of rows, at least 1
     */
    public record Crop(int x, int y, int width, int height) {}

    public RenderSettings {
        Objects.requireNonNull(method, "method");
        Objects.requireNonNull(budget, "budget");
        Distribution.of(proposal);
        Scene.checkSize(width, height);
        if (crop.isPresent()) {
            Crop c = crop.get();
            boolean inside = c.x >= 0
                    && c.y >= 0
                    && c.width >= 1
                    && c.height >= 1
                    && (long) c.x + c.width <= width
                    && (long) c.y + c.height <= height;
            Check.that(
                    inside,
                    "crop",
                    "must lie inside the picture of " + width + "x" + height + " pixels, not " + c.x + "," + c.y + ","
                            + c.width + "," + c.height);
        }
        // One place knows the limits.
        new RenderDefaults(method, antialias, shadowSamples, seed);
        Check.that(threads >= 1 && threads <= 4096, "threads", "must lie in 1..4096, not " + threads);
        Check.that(tileSize >= 1, "tileSize", "must be at least 1, not " + tileSize);
    }

    /** What the scene asks for, on all processors. */
    public static RenderSettings of(Scene scene) {
        RenderDefaults d = scene.render();
        return new RenderSettings(
                d.method(),
                scene.width(),
                scene.height(),
                Optional.empty(),
                d.antialias(),
                d.shadowSamples(),
                d.seed(),
                Budget.NONE,
                Distribution.NAMES.get(0),
                Runtime.getRuntime().availableProcessors(),
                DEFAULT_TILE_SIZE);
    }

    public RenderSettings withMethod(String value) {
        return new RenderSettings(
                value, width, height, crop, antialias, shadowSamples, seed, budget, proposal, threads, tileSize);
    }

    public RenderSettings withSize(int w, int h) {
        return new RenderSettings(
                method, w, h, crop, antialias, shadowSamples, seed, budget, proposal, threads, tileSize);
    }

    public RenderSettings withCrop(Crop value) {
        return new RenderSettings(
                method,
                width,
                height,
                Optional.of(value),
                antialias,
                shadowSamples,
                seed,
                budget,
                proposal,
                threads,
                tileSize);
    }

    public RenderSettings withAntialias(int value) {
        return new RenderSettings(
                method, width, height, crop, value, shadowSamples, seed, budget, proposal, threads, tileSize);
    }

    public RenderSettings withShadowSamples(int value) {
        return new RenderSettings(
                method, width, height, crop, antialias, value, seed, budget, proposal, threads, tileSize);
    }

    public RenderSettings withSeed(long value) {
        return new RenderSettings(
                method, width, height, crop, antialias, shadowSamples, value, budget, proposal, threads, tileSize);
    }

    public RenderSettings withBudget(Budget value) {
        return new RenderSettings(
                method, width, height, crop, antialias, shadowSamples, seed, value, proposal, threads, tileSize);
    }

    public RenderSettings withProposal(String value) {
        return new RenderSettings(
                method, width, height, crop, antialias, shadowSamples, seed, budget, value, threads, tileSize);
    }

    public RenderSettings withThreads(int value) {
        return new RenderSettings(
                method, width, height, crop, antialias, shadowSamples, seed, budget, proposal, value, tileSize);
    }

    public RenderSettings withTileSize(int value) {
        return new RenderSettings(
                method, width, height, crop, antialias, shadowSamples, seed, budget, proposal, threads, value);
    }

    /** The part of the picture that is rendered: the crop, or all of it. */
    public Crop region() {
        return crop.orElse(new Crop(0, 0, width, height));
    }
}
