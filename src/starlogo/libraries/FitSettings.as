package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.fitting.Fitter;
    import starlogo.geometry.Fingerprint;

    use namespace engine;

    /**
     * Every setting that decides what the libraries compute for a model, as it is when this object is made: fits that were computed with other
     * settings are not used. Settings that only choose among what was computed are not part of it: cheaperTestsFactor, keepAll, boundsKind.
     */
    public final class FitSettings
    {
        /** Has to be raised whenever an algorithm of the engine gives another result for the same settings. */
        private static const REVISION:int = 5;

        /**
         * The settings that structures depend on; null if structures are not wanted, or cannot be kept.
         *
         * @private
         */
        engine var structures:Fingerprint = null;

        /**
         * The settings that a hierarchy depends on; null if none is wanted.
         *
         * @private
         */
        engine var hierarchy:Fingerprint = null;

        /**
         * Whether what exact colliders need is wanted.
         *
         * @private
         */
        engine var wantsSurface:Boolean = false;

        /**
         * The settings of libraries as they are now.
         *
         * @param structures finds structures; null if none are wanted
         * @param hierarchies builds hierarchies; null if none are wanted
         */
        public function FitSettings(structures:BoundingStructuresLibrary, hierarchies:HierarchiesLibrary)
        {
            if (structures != null)
            {
                this.structures = fingerprintOfAll(structures.fitters);
            }
            if (hierarchies != null)
            {
                hierarchy = fingerprintOf(["hierarchy", hierarchies.minVerticesToSplit, hierarchies.maxDepth, hierarchies.splitByMean].join());
                wantsSurface = hierarchies.prepareExact;
            }
        }

        /** All of them in sixteen hexadecimal digits. */
        public function toString():String
        {
            return fingerprintOf([structures, hierarchy, wantsSurface].join()).toString();
        }

        // null if one of the fitters has no signature
        private static function fingerprintOfAll(fitters:Vector.<Fitter>):Fingerprint
        {
            var signatures:Array = ["structures"];
            for each (var fitter:Fitter in fitters)
            {
                if (fitter == null || fitter.signature == null)
                {
                    return null;
                }
                signatures.push(fitter.signature);
            }
            return fingerprintOf(signatures.join(", "));
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
