package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.listen.SmallHttp;
import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import enlightenment.status.QuickPng;
import enlightenment.view.frame.ErrorPoint;
import enlightenment.view.frame.FrameBuilder;
import enlightenment.view.frame.FrameDetail;
import enlightenment.view.frame.Kept;
import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** Answers requests for layers, the kept picture, and the convergence of the error. Thread-safe. */
final class LookPages {
    private final ViewSession session;

    /** Layers of the last picture that have been requested. */
    private final Map<Layer, LayerPicture> made = new EnumMap<>(Layer.class);

    /** Number of the picture that the layers in {@link #made} belong to. */
    private long madeOf;

    private final DenoisedPicture denoised = new DenoisedPicture();

    private Kept comparedWith;

    private MaterialIndex materials;

    /** The scene of {@link #materials}; null until they are needed. */
    private Scene indexed;

    LookPages(ViewSession session) {
        this.session = session;
    }

    /**
     * Answers a request.
     *
     * @throws BadParameter if the request names no valid layer or place
     */
    SmallHttp.Answer answer(SmallHttp.Request request) throws IOException {
        try {
            return switch (request.path()) {
                case "/layer.png" -> png(layer(request).image());
                case "/layer.json" -> SmallHttp.Answer.json(LookJson.layer(wanted(request), layer(request)));
                case "/value.json" -> value(request);
                case "/kept.png" -> kept();
                case "/convergence.json" -> convergence();
                default -> SmallHttp.Answer.text(404, "there is no such page\n");
            };
        } catch (LayerPicture.Missing e) {
            return SmallHttp.Answer.text(404, e.getMessage() + "\n");
        }
    }

    /** Requests the layer that the page shows, if its request names one. */
    void wish(SmallHttp.Request request) {
        if (request.value("layer").isPresent()) {
            Layer layer = Layer.of(request.value("layer").get());
            Snapshot now = session.snapshot();
            if (now.scene() != null && layer.isOf(now.scene())) {
                session.wish(layer);
            }
        }
    }

    private static Layer wanted(SmallHttp.Request request) {
        Layer layer = Layer.of(request.value("layer").orElse(""));
        if (layer == Layer.PICTURE) {
            throw new BadParameter("the picture is at picture.png");
        }
        return layer;
    }

    private LayerPicture layer(SmallHttp.Request request) throws LayerPicture.Missing {
        return layer(wanted(request), session.snapshot());
    }

    private LayerPicture layer(Layer layer, Snapshot now) throws LayerPicture.Missing {
        if (now.scene() != null && !layer.isOf(now.scene())) {
            throw new LayerPicture.Missing(layer.word() + " is for physical shading");
        }
        session.wish(layer);
        return made(layer, now);
    }

    /** The picture of a layer. Synchronized, so that concurrent requests make it once. */
    private synchronized LayerPicture made(Layer layer, Snapshot now) throws LayerPicture.Missing {
        if (madeOf != now.picture() || comparedWith != now.kept()) {
            made.clear();
            madeOf = now.picture();
            comparedWith = now.kept();
        }
        if (layer == Layer.MATERIAL) {
            now.layers().of(RenderResult.Auxiliary.OBJECT).ifPresent(objects -> index(objects.scene()));
        }
        LayerPicture picture = made.get(layer);
        if (picture == null) {
            picture = layer == Layer.DENOISED ? denoised.at(now, session) : LayerPicture.of(layer, now, materials);
            made.put(layer, picture);
        }
        return picture;
    }

    private void index(Scene scene) {
        if (indexed != scene) {
            indexed = scene;
            materials = new MaterialIndex(scene);
        }
    }

    private SmallHttp.Answer value(SmallHttp.Request request) throws LayerPicture.Missing {
        double x = ViewActions.number(request, "x", 0, 1);
        double y = ViewActions.number(request, "y", 0, 1);
        Layer layer = wanted(request);
        Snapshot now = session.snapshot();
        LayerPicture picture = layer(layer, now);
        Image numbers = picture.numbers();
        int column = Math.min((int) (x * numbers.width()), numbers.width() - 1);
        int row = Math.min((int) (y * numbers.height()), numbers.height() - 1);
        if (picture.names() != null) {
            int number = (int) numbers.component(column, row, 0);
            return SmallHttp.Answer.json(
                    LookJson.name(number < 0 ? "nothing" : picture.names().apply(number)));
        }
        return SmallHttp.Answer.json(LookJson.values(numbers, layer.components(), column, row));
    }

    private SmallHttp.Answer kept() throws IOException, LayerPicture.Missing {
        Kept kept = session.snapshot().kept();
        if (kept == null) {
            throw new LayerPicture.Missing("there is no picture A");
        }
        return png(kept.image());
    }

    /** Errors at the current exposure, on which they depend: after a change of exposure that of the present picture alone. */
    private SmallHttp.Answer convergence() {
        Snapshot now = session.snapshot();
        List<ErrorPoint> points = new ArrayList<>();
        if (now.frame() != null) {
            FrameDetail detail = now.frame().detail();
            detail.errors().stream().filter(p -> p.exposure() == now.exposure()).forEach(points::add);
            int last = detail.errors().size() - 1;
            if (last >= 0 && detail.errors().get(last).exposure() != now.exposure()) {
                detail.noise()
                        .ifPresent(n -> points.add(new ErrorPoint(
                                detail.seconds(),
                                now.frame().samples(),
                                n.rmse(FrameBuilder.curve(now.frame().image(), now.exposure())),
                                now.exposure())));
            }
        }
        return SmallHttp.Answer.json(LookJson.convergence(points));
    }

    private static SmallHttp.Answer png(Image image) throws IOException {
        return new SmallHttp.Answer(200, "image/png", QuickPng.of(image));
    }
}
