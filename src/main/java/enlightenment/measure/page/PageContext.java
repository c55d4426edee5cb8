package enlightenment.measure.page;

import java.util.Map;

/**
 * What the page tells that the measurements do not know.
 *
 * @param title the scene's name
 * @param renderCommand the command line of the advice as far as it does not depend on it: program, scene, target, options
 * @param compareCommand the command line that checks the picture against the reference
 * @param tradeCommand the command line that made the page
 * @param machine what it was measured on, label by label
 */
public record PageContext(
        String title, String renderCommand, String compareCommand, String tradeCommand, Map<String, String> machine) {}
