package enlightenment.cli.input;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.DecimalNumber;
import enlightenment.cli.option.WordOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.importer.SceneImporter;
import enlightenment.importer.SceneImporter.Options.Orbit;
import enlightenment.importer.SceneImporter.Options.Up;
import enlightenment.text.Plain;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;

/** The options for files of other programs, which have to be told what a scene file says by itself. */
public final class ForeignOptions {
    @Option(
            names = "--camera",
            paramLabel = "NAME",
            description = "file of another program: the camera of this name or number, counted from 0")
    private String camera;

    @Option(
            names = "--view",
            paramLabel = "AZIMUTH,ELEVATION",
            converter = OrbitConverter.class,
            description =
                    "file of another program: see the whole model from this many degrees to the right of its front"
                            + " and above the horizon, in place of its camera")
    private Orbit view;

    @Option(
            names = "--up",
            paramLabel = "AXIS",
            converter = UpWords.class,
            completionCandidates = UpWords.class,
            description = "file of another program: the axis that points upwards: ${COMPLETION-CANDIDATES}")
    private Up up;

    @Option(
            names = "--background",
            paramLabel = "COLOR",
            converter = BackdropConverter.class,
            completionCandidates = BackdropWords.class,
            description = "file of another program: what surrounds it: ${COMPLETION-CANDIDATES} or #rrggbb")
    private SceneImporter.Options.Backdrop background;

    @Option(
            names = "--fps",
            paramLabel = "N",
            converter = Rate.class,
            description = "file of another program: frames in a second of its animation")
    private Double framesPerSecond;

    @Option(
            names = "--animation",
            paramLabel = "NAME",
            description = "file of another program: the animation of this name or number, counted from 0")
    private String animation;

    @Option(
            names = "--assets",
            paramLabel = "DIR",
            description = "file of another program: a folder that the files which it names may lie in, beside its own")
    private Path assets;

    /** Options that were not given. */
    public ForeignOptions() {}

    /** Fails where options exclude each other. */
    public void check() {
        if (camera != null && view != null) {
            throw CliException.wrongUsage("--camera and --view choose the view each: one of them is needed");
        }
    }

    /** The choices for the importer; fails if the folder of assets is none. */
    public SceneImporter.Options options() {
        if (assets != null && !Files.isDirectory(assets)) {
            throw CliException.wrongUsage("--assets: there is no folder " + Plain.quoted(assets.toString()));
        }
        SceneImporter.Options usual = SceneImporter.Options.DEFAULT;
        return new SceneImporter.Options(
                usual.extracted(),
                Optional.ofNullable(up),
                Optional.ofNullable(camera),
                Optional.ofNullable(view),
                Optional.ofNullable(background),
                framesPerSecond == null ? usual.framesPerSecond() : framesPerSecond,
                Optional.ofNullable(animation),
                Optional.ofNullable(assets));
    }

    /** Fails if one is given for a file that is none of another program. */
    public void refuse(String name) {
        List<String> given = given();
        if (!given.isEmpty()) {
            throw CliException.wrongUsage(String.join(", ", given)
                    + (given.size() == 1 ? " is" : " are") + " for files of other programs: " + name
                    + " says by itself what it shows");
        }
    }

    private List<String> given() {
        List<String> given = new ArrayList<>();
        if (camera != null) {
            given.add("--camera");
        }
        if (view != null) {
            given.add("--view");
        }
        if (up != null) {
            given.add("--up");
        }
        if (background != null) {
            given.add("--background");
        }
        if (framesPerSecond != null) {
            given.add("--fps");
        }
        if (animation != null) {
            given.add("--animation");
        }
        if (assets != null) {
            given.add("--assets");
        }
        return given;
    }

    static final class Rate extends DecimalNumber {
        private static final double MIN = 0.001;
        private static final double MAX = 1000;

        Rate() {
            super(MIN, MAX);
        }
    }

    static final class UpWords extends WordOption<Up> {
        UpWords() {
            super(List.of(Up.values()));
        }

        @Override
        protected String word(Up value) {
            return value.name().toLowerCase(Locale.ROOT).replace("minus_", "-");
        }
    }

    /** Two angles with a comma. */
    static final class OrbitConverter implements ITypeConverter<Orbit> {
        @Override
        public Orbit convert(String text) {
            String[] angles = text.split(",", -1);
            try {
                if (angles.length == 2) {
                    return new Orbit(
                            DecimalNumber.parse(angles[0], -360, 360), DecimalNumber.parse(angles[1], -90, 90));
                }
            } catch (BadValue e) {
                // Told below with both ranges.
            }
            throw BadValue.expected("AZIMUTH,ELEVATION in degrees, -360..360 and -90..90, such as 30,20", text);
        }
    }

    /** The surroundings that have a name. */
    static final class BackdropWords extends WordOption<String> {
        BackdropWords() {
            super(List.of("studio", "sky", "white", "black"));
        }
    }

    static final class BackdropConverter implements ITypeConverter<SceneImporter.Options.Backdrop> {
        private static final Map<String, SceneImporter.Options.Backdrop> NAMED = Map.of(
                "studio", new SceneImporter.Options.Backdrop.Studio(),
                "sky", new SceneImporter.Options.Backdrop.Sky(),
                "white", new SceneImporter.Options.Backdrop.Constant(Rgb.WHITE),
                "black", new SceneImporter.Options.Backdrop.Constant(Rgb.BLACK));

        @Override
        public SceneImporter.Options.Backdrop convert(String text) {
            if (NAMED.containsKey(text)) {
                return NAMED.get(text);
            }
            return DisplayRgb.ofHexadecimal(text)
                    .map(color -> new SceneImporter.Options.Backdrop.Constant(color.linear()))
                    .orElseThrow(() -> BadValue.expected("studio, sky, white, black or #rrggbb", text));
        }
    }
}
