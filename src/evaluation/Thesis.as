package evaluation
{
    /** The numbers of the thesis's section 6. */
    public final class Thesis
    {
        /** The structures that Figure 6-1 compares. */
        public static const STRUCTURES:Array = ["naive sphere", "Ritter sphere", "axis-aligned box", "z-aligned box",
                "oriented box", "oriented capsule"];

        /** Figure 6-1: the volumes of these structures around each model. */
        public static const VOLUMES:Object = {
                sphere: [0.524, 0.524, 0.989, 0.953, 0.959, 0.596], cube: [2.721, 5.216, 1, 1, 1, 3.052],
                cylinder: [1.803, 4.577, 1.131, 1.121, 1.123, 1.412], bear: [6.441, 6.403, 1.842, 1.701, 1.657, 1.843],
                dragon: [0.598, 0.576, 0.298, 0.236, 0.238, 0.593], seagull: [1.061, 1.053, 0.333, 0.333, 0.282, 0.899],
                tree: [7.025, 6.977, 2.253, 2.132, 2.056, 2.686], kelp: [0.524, 0.524, 0.011, 0.011, 0.011, 0.026],
                fortress: [1.768, 1.769, 0.501, 0.501, 0.501, 1.716], spaceship: [0.527, 0.524, 0.173, 0.167, 0.168, 0.636],
                fireman: [7.909, 7.861, 1.733, 1.630, 1.635, 2.517], person: [0.674, 0.807, 0.259, 0.220, 0.221, 0.682]};

        /** Figure 6-2: milliseconds to find the tightest fit. */
        public static const FIT_MS:Object = {sphere: 223, cube: 27, cylinder: 318, bear: 555, dragon: 3000, seagull: 924,
                tree: 416, kelp: 67, fortress: 398, spaceship: 240, fireman: 1061, person: 578};

        /** Figure 6-3: milliseconds to access and transform a tightest fit. */
        public static const ACCESS_MS:Object = {cube: 0.003736, sphere: 0.002339, cylinder: 0.004173, bear: 0.004441,
                dragon: 0.004708};

        /** Figure 6-4: milliseconds for an intersection test. */
        public static const TEST_MS:Object = {sphereSphere: 0.000319, capsuleCapsule: 0.003608, boxBox: 0.11717,
                sphereCapsule: 0.002136, sphereBox: 0.002191, capsuleBox: 0.04275};

        /** Figure 6-5: milliseconds to construct a hierarchy. */
        public static const HIERARCHY_MS:Object = {sphere: 0.536, cube: 0.066, cylinder: 1.685, bear: 3.722, dragon: 25.542,
                seagull: 7.728, tree: 3.964, kelp: 0.359, fortress: 3.874, spaceship: 3.016, fireman: 10.479, person: 5.551};

        /** Sections 6.1, 6.2.5 and 6.3.4: milliseconds for the collisions of a crowd. */
        public static const CROWD_MS:Object = {
                "BinCollider 100 spheres": 30, "BinCollider 100 bears": 30, "BinCollider 100 mix": 30,
                "TightestFitCollider 100 spheres": 78, "TightestFitCollider 100 bears": 1300,
                "HierarchicalCollider 10 spheres": 75, "HierarchicalCollider 10 bears": 75,
                "HierarchicalCollider 100 spheres": 7500, "HierarchicalCollider 100 bears": 7500};
    }
}
