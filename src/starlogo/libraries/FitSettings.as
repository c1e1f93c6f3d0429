package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.fitting.Fitter;
    import starlogo.geometry.Fingerprint;

    use namespace engine;

    /**
     * The settings that decide the results that libraries compute for a model. They are copied when this object is made. Fits that were
     * computed with other settings are not used. The setting keepAll is not part of it, because it only says which results a client may read.
     */
    public final class FitSettings
    {
        /** Increase it whenever an algorithm of the engine gives other results for the same settings. */
        private static const REVISION:int = 10;

        /**
         * The settings for structures; null if structures are not wanted, or cannot be kept.
         *
         * @private
         */
        engine var structures:Fingerprint = null;

        /**
         * The settings for a hull; null if none is wanted, or it cannot be kept.
         *
         * @private
         */
        engine var hull:Fingerprint = null;

        /**
         * The settings for a hierarchy; null if none is wanted.
         *
         * @private
         */
        engine var hierarchy:Fingerprint = null;

        /**
         * Whether the surface for exact colliders is wanted.
         *
         * @private
         */
        engine var wantsSurface:Boolean = false;

        /**
         * Copies the present settings of the libraries.
         *
         * @param structures the library of structures; null if none are wanted
         * @param hierarchies the library of hierarchies; null if none are wanted
         */
        public function FitSettings(structures:BoundingStructuresLibrary, hierarchies:HierarchiesLibrary)
        {
            if (structures != null)
            {
                var signatures:String = signaturesOf(structures.fitters);
                this.structures = signatures == null ? null : fingerprintOf("structures, " + signatures);
                // The smallest sphere may take the hull's place.
                hull = signatures == null || !structures.keepHulls ? null : fingerprintOf(structures.hullFitter.signature + ", " + signatures);
            }
            if (hierarchies != null)
            {
                hierarchy = fingerprintOf(["hierarchy", hierarchies.minVerticesToSplit, hierarchies.maxDepth, hierarchies.splitByMean].join());
                wantsSurface = hierarchies.prepareExact;
            }
        }

        /** All settings as sixteen hexadecimal digits. */
        public function toString():String
        {
            var all:Array = [structures, hierarchy, wantsSurface];
            return fingerprintOf((hull == null ? all : all.concat(hull)).join()).toString();
        }

        // null if a fitter has no signature
        private static function signaturesOf(fitters:Vector.<Fitter>):String
        {
            var signatures:Array = [];
            for each (var fitter:Fitter in fitters)
            {
                if (fitter == null || fitter.signature == null)
                {
                    return null;
                }
                signatures.push(fitter.signature);
            }
            return signatures.join(", ");
        }

        private static function fingerprintOf(text:String):Fingerprint
        {
            var fingerprint:Fingerprint = new Fingerprint();
            fingerprint.addWord(REVISION);
            fingerprint.addText(text);
            return fingerprint;
        }
    }
}
