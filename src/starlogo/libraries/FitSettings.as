package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.data.Fingerprint;
    import starlogo.engine;
    import starlogo.fitting.Fitter;
    import starlogo.models.cooked.CookedFile;

    use namespace engine;

    /**
     * The settings that decide the results that libraries compute for a model. They are copied when this object is made. Fits that were
     * computed with other settings are not used. Fits with another <code>keepAll</code> are used, because that only says which results a client may read.
     */
    public final class FitSettings
    {
        // Increase it whenever an algorithm of the engine gives other results for the same settings.
        private static const REVISION:int = 18;

        // The fingerprint of the settings of each section of a cooked file; null if its results are not wanted, or cannot be kept.
        private var _keys:Vector.<Fingerprint> = new Vector.<Fingerprint>(CookedFile.SECTION_COUNT, true);

        /** @private The library's <code>prepareExact</code>. */
        engine var preparesExact:Boolean = false;

        /** @private The deepest level of hierarchies. */
        engine var maxDepth:int = 0;

        /**
         * Copies the present settings of the libraries.
         *
         * @param structures the library of structures; null if none are wanted
         * @param hierarchies the library of hierarchies; null if none are wanted
         */
        public function FitSettings(structures:BoundingStructuresLibrary, hierarchies:HierarchiesLibrary)
        {
            var signatures:String = structures == null ? null : signaturesOf(structures.fitters);
            if (signatures != null)
            {
                _keys[CookedFile.STRUCTURES] = fingerprintOf("structures, " + signatures);
                // The smallest sphere may take the hull's place.
                _keys[CookedFile.HULL] = structures.keepHulls ? fingerprintOf(structures.hullFitter.signature + ", " + signatures) : null;
            }
            if (hierarchies != null)
            {
                _keys[CookedFile.HIERARCHY] = _keys[CookedFile.SURFACE] =
                    fingerprintOf(["hierarchy", hierarchies.minVerticesToSplit, hierarchies.maxDepth, hierarchies.splitByMean].join());
                preparesExact = hierarchies.prepareExact;
                maxDepth = hierarchies.maxDepth;
            }
        }

        /** @private Whether a hull is wanted, and can be stored. */
        engine function get storesHull():Boolean
        {
            return _keys[CookedFile.HULL] != null;
        }

        /** All settings as sixteen hexadecimal digits. */
        public function toString():String
        {
            var all:Array = [_keys[CookedFile.STRUCTURES], _keys[CookedFile.HIERARCHY], preparesExact];
            return fingerprintOf((storesHull ? all.concat(_keys[CookedFile.HULL]) : all).join()).toString();
        }

        /** @private A section of a cooked file; null if it is empty, has other settings, or is not wanted. */
        engine function sectionOf(file:CookedFile, section:int):ByteArray
        {
            return _keys[section] == null ? null : file.section(section, _keys[section]);
        }

        /** @private The keys for all sections of a cooked file. @param modelKey see <code>CookedFile.MODEL</code> */
        engine function keysWith(modelKey:Fingerprint):Vector.<Fingerprint>
        {
            var all:Vector.<Fingerprint> = _keys.concat();
            all[CookedFile.MODEL] = modelKey;
            return all;
        }

        // Null if a fitter has no signature. A comma within a signature is doubled, so that other fitters give another text.
        private static function signaturesOf(fitters:Vector.<Fitter>):String
        {
            var signatures:Array = [];
            for each (var fitter:Fitter in fitters)
            {
                if (fitter == null || !fitter.signature)
                {
                    return null;
                }
                signatures.push(fitter.signature.split(",").join(",,"));
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
