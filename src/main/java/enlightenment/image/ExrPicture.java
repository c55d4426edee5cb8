package enlightenment.image;

import enlightenment.codec.ExrChannel;
import enlightenment.codec.ExrWindow;
import enlightenment.codec.ExrWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;

/** A picture with its layers, on its way into an OpenEXR file. */
final class ExrPicture {
    private record Source(Image image, int component) {}

    private final Image image;
    private final List<ExrChannel> channels = new ArrayList<>();
    private final List<Source> sources = new ArrayList<>();

    private ExrPicture(Image image, ImageFiles.ExrOptions options) {
        this.image = image;
        channels.addAll(ExrChannel.rgb(options.depth() == 16));
        for (int c = 0; c < 3; c++) {
            sources.add(new Source(image, c));
        }
        for (ImageFiles.ExrOptions.Layer layer : options.layers()) {
            if (layer.image().width() != image.width() || layer.image().height() != image.height()) {
                throw new IllegalArgumentException("layer " + layer.name() + " has " + size(layer.image())
                        + " pixels, the picture " + size(image));
            }
            for (int c = 0; c < layer.channels().size(); c++) {
                channels.add(
                        new ExrChannel(layer.name() + "." + layer.channels().get(c), false));
                sources.add(new Source(layer.image(), c));
            }
        }
    }

    static void write(Image image, OutputStream out, ImageFiles.ExrOptions options) throws IOException {
        new ExrPicture(image, options).write(out, options);
    }

    private void write(OutputStream out, ImageFiles.ExrOptions options) throws IOException {
        ExrWriter writer = new ExrWriter(out, window(options), channels, options.text());
        if (!image.isInMemory()) {
            writer.measure();
            addRows(writer);
        }
        addRows(writer);
        writer.finish();
    }

    private void addRows(ExrWriter writer) throws IOException {
        float[][] row = new float[sources.size()][image.width()];
        for (int y = 0; y < image.height(); y++) {
            for (int c = 0; c < row.length; c++) {
                Source source = sources.get(c);
                for (int x = 0; x < image.width(); x++) {
                    row[c][x] = source.image.component(x, y, source.component);
                }
            }
            writer.add(row);
        }
    }

    private ExrWindow window(ImageFiles.ExrOptions options) {
        return options.place()
                .map(p -> new ExrWindow(p.x(), p.y(), image.width(), image.height(), p.wholeWidth(), p.wholeHeight()))
                .orElseGet(() -> ExrWindow.whole(image.width(), image.height()));
    }

    private static String size(Image image) {
        return image.width() + "x" + image.height();
    }
}
