package enlightenment.image;

import enlightenment.check.Check;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * How an OpenEXR file is written.
 *
 * @param depth bits per component of the picture: 32 keeps every float, 16 rounds to halves (11 bits, up to 65504)
 * @param place where a part of a larger picture lies; empty for a whole picture
 * @param text what the file says of itself: attributes of type string. A name has 1..31 printable ASCII characters without spaces and
 *     is none of the attributes that every file has, such as {@code channels}
 * @param layers further channels, in floats
 */
public record ExrOptions(int depth, Optional<Place> place, Map<String, String> text, List<Layer> layers) {
    /** Floats of a whole picture, nothing else. */
    public static final ExrOptions DEFAULT = new ExrOptions(32, Optional.empty(), Map.of(), List.of());

    /**
     * The place of a picture's upper left pixel in a larger picture: the file's data window within its display window.
     *
     * @param x column of the larger picture
     * @param y row of the larger picture, from the top
     * @param wholeWidth columns of the larger picture
     * @param wholeHeight rows of the larger picture
     */
    public record Place(int x, int y, int wholeWidth, int wholeHeight) {}

    /**
     * Further numbers of each pixel: channels {@code name.X} for each X of the list.
     *
     * @param name of the layer; with a dot and a channel's name at most 31 characters
     * @param channels the last parts of the channels' names: three, or one if the components are equal
     * @param image the numbers, of the picture's size
     */
    public record Layer(String name, List<String> channels, Image image) {
        /** @throws IllegalArgumentException unless there are one or three channels */
        public Layer {
            channels = List.copyOf(channels);
            Check.that(
                    channels.size() == 1 || channels.size() == 3,
                    "channels",
                    "must be one or three, not " + channels.size());
        }
    }

    /** @throws IllegalArgumentException if the depth is neither 16 nor 32 */
    public ExrOptions {
        Check.that(depth == 16 || depth == 32, "depth", "must be 16 or 32 bits per component, not " + depth);
        text = Collections.unmodifiableMap(new LinkedHashMap<>(text));
        layers = List.copyOf(layers);
    }

    /** These options with another depth. */
    public ExrOptions withDepth(int newDepth) {
        return new ExrOptions(newDepth, place, text, layers);
    }

    /** These options for a part of a larger picture. */
    public ExrOptions withPlace(Place newPlace) {
        return new ExrOptions(depth, Optional.of(newPlace), text, layers);
    }

    /** These options with other texts. */
    public ExrOptions withText(Map<String, String> newText) {
        return new ExrOptions(depth, place, newText, layers);
    }

    /** These options with one more layer. */
    public ExrOptions withLayer(Layer layer) {
        List<Layer> extended = new ArrayList<>(layers);
        extended.add(layer);
        return new ExrOptions(depth, place, text, extended);
    }
}
