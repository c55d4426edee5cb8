package enlightenment.job;

import enlightenment.file.ContentHash;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What has to be the same for results of units to belong to one picture, whatever its number of samples: so the budget is not among it,
 * nor what has no influence on the picture.
 *
 * @param scene the hash of the scene with its image files ({@link SceneDocument#hash})
 * @param settings the settings as words, {@code size 240x200, seed 1, ...}
 * @param build which version of the program ({@link Build#number})
 */
public record RenderIdentity(ContentHash scene, String settings, String build) {
    private static final String BETWEEN = ", ";

    /** Longer texts of settings are not told. */
    private static final int MOST_WORDS = 200;

    public RenderIdentity {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(build, "build");
    }

    /** That of a scene rendered by this version with these settings. */
    public static RenderIdentity of(ContentHash scene, RenderSettings settings, String build) {
        List<String> words = new ArrayList<>();
        words.add("method " + settings.method().word());
        words.add("size " + settings.width() + "x" + settings.height());
        settings.crop().ifPresent(c -> words.add("crop " + c.x() + " " + c.y() + " " + c.width() + " " + c.height()));
        List<Method.Setting> all = new ArrayList<>(ChosenSettings.Common.ALL);
        all.addAll(Method.influences(settings.method()));
        all.forEach(setting -> words.add(setting.key() + " " + settings.chosen().value(setting)));
        return new RenderIdentity(scene, String.join(BETWEEN, words), build);
    }

    /** A hash of all of it. */
    public ContentHash id() {
        return ContentHash.of((scene + "\n" + settings + "\n" + build).getBytes(StandardCharsets.UTF_8));
    }

    /**
     * What differs, in words for the user who has these results and wants that render; empty if nothing does.
     *
     * @param wanted the render that is to go on
     */
    public Optional<String> difference(RenderIdentity wanted) {
        List<String> all = new ArrayList<>();
        if (!build.equals(wanted.build)) {
            all.add("the version (" + build + " there, " + wanted.build + " here)");
        }
        if (!scene.equals(wanted.scene)) {
            all.add("the scene or one of its image files");
        }
        if (!settings.equals(wanted.settings)) {
            all.add("the settings (" + changes(words(settings), words(wanted.settings)) + ")");
        }
        return all.isEmpty() ? Optional.empty() : Optional.of(String.join(" and ", all));
    }

    private static Map<String, String> words(String settings) {
        Map<String, String> words = new LinkedHashMap<>();
        for (String pair : settings.split(BETWEEN)) {
            int space = pair.indexOf(' ');
            words.put(pair.substring(0, Math.max(space, 0)), pair.substring(space + 1));
        }
        return words;
    }

    private static String changes(Map<String, String> kept, Map<String, String> wanted) {
        Map<String, String> all = new LinkedHashMap<>(kept);
        wanted.forEach(all::putIfAbsent);
        List<String> changes = new ArrayList<>();
        for (String key : all.keySet()) {
            String before = kept.getOrDefault(key, "none");
            String now = wanted.getOrDefault(key, "none");
            if (!before.equals(now)) {
                changes.add(key + " " + before + " there, " + now + " here");
            }
        }
        String words = String.join("; ", changes);
        return words.length() > MOST_WORDS ? words.substring(0, MOST_WORDS) + "..." : words;
    }
}
