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
        private static const REVISION:int = 16;

        // For each section of a cooked file, the settings of what is in it, as a text. Null if that is not wanted, or cannot be kept.
        private var _settingsOfSections:Vector.<String> = new Vector.<String>(CookedFile.SECTION_COUNT, true);

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
            if (structures != null)
            {
                var signatures:String = signaturesOf(structures.fitters);
                _settingsOfSections[CookedFile.STRUCTURES] = signatures == null ? null : "structures, " + signatures;
                // The smallest sphere may take the hull's place.
                _settingsOfSections[CookedFile.HULL] = signatures == null || !structures.keepHulls ? null : structures.hullFitter.signature + ", " + signatures;
            }
            if (hierarchies != null)
            {
                _settingsOfSections[CookedFile.HIERARCHY] = _settingsOfSections[CookedFile.SURFACE] =
                    ["hierarchy", hierarchies.minVerticesToSplit, hierarchies.maxDepth, hierarchies.splitByMean].join();
                preparesExact = hierarchies.prepareExact;
                maxDepth = hierarchies.maxDepth;
            }
        }

        /** @private Whether a hull is wanted, and can be stored. */
        engine function get keepsHull():Boolean
        {
            return _settingsOfSections[CookedFile.HULL] != null;
        }

        /** All settings as sixteen hexadecimal digits. */
        public function toString():String
        {
            var all:Array = [fingerprintOf(CookedFile.STRUCTURES), fingerprintOf(CookedFile.HIERARCHY), preparesExact];
            var hull:Fingerprint = fingerprintOf(CookedFile.HULL);
            return fingerprintWithRevision((hull == null ? all : all.concat(hull)).join()).toString();
        }

        /** @private A section of a cooked file; null if it is empty, has other settings, or is not wanted. */
        engine function sectionOf(file:CookedFile, section:int):ByteArray
        {
            var wanted:Fingerprint = fingerprintOf(section);
            return wanted == null ? null : file.section(section, wanted);
        }

        /** @private The fingerprints for all sections of a cooked file. @param modelKey see <code>CookedFile.MODEL</code> */
        engine function fingerprintsWith(modelKey:Fingerprint):Vector.<Fingerprint>
        {
            var all:Vector.<Fingerprint> = new <Fingerprint>[modelKey];
            for (var section:int = CookedFile.MODEL + 1; section < CookedFile.SECTION_COUNT; section++)
            {
                all.push(fingerprintOf(section));
            }
            return all;
        }

        // The fingerprint of a section's settings; null if its results are not wanted, or cannot be kept.
        private function fingerprintOf(section:int):Fingerprint
        {
            return _settingsOfSections[section] == null ? null : fingerprintWithRevision(_settingsOfSections[section]);
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

        private static function fingerprintWithRevision(text:String):Fingerprint
        {
            var fingerprint:Fingerprint = new Fingerprint();
            fingerprint.addWord(REVISION);
            fingerprint.addText(text);
            return fingerprint;
        }
    }
}
