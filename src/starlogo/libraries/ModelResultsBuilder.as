package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.libraries.cooked.TreeReader;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedShape;
    import starlogo.solid.SolidHierarchyBuilder;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Gets the results that the libraries need for one model. It takes them from the model's cooked file, otherwise from a store. It
     * computes the results that are missing and adds them to the store.
     *
     * @private
     */
    public final class ModelResultsBuilder extends StepSequence
    {
        /** The builder that has the hierarchy or builds it when it is needed. Read it when no step is left. Null if none was wanted. */
        public var hierarchy:SolidHierarchyBuilder;

        private var _model:Model;
        private var _structures:StructuresBuilder;
        private var _settings:FitSettings;
        private var _store:FitStore;
        private var _geometry:Fingerprint = new Fingerprint();
        private var _fits:ModelFits = new ModelFits();

        /**
         * @param model the model
         * @param structures finds its structures; null if none are wanted
         * @param hierarchy builds its hierarchy; null if none is wanted
         * @param settings the settings of the libraries that want them
         * @param store null for none
         */
        public function ModelResultsBuilder(model:Model, structures:StructuresBuilder, hierarchy:SolidHierarchyBuilder, settings:FitSettings,
                store:FitStore)
        {
            _model = model;
            _structures = structures;
            _settings = settings;
            this.hierarchy = hierarchy;
            if (model.data.cooked != null)
            {
                _fits.readFrom(model.data.cooked, model, settings);
            }
            _store = isComplete ? null : store;
            if (_store != null)
            {
                add(store.reading(model, _geometry, settings, _fits));
            }
            call(useFits);
            if (structures != null)
            {
                add(structures);
            }
            if (hierarchy != null)
            {
                begin(divide);
            }
            if (_store != null)
            {
                call(keep);
            }
        }

        /** The structures, when no step is left; null if none were wanted. */
        public function get structures():ShapeStructures
        {
            return _structures == null ? null : _structures.structures;
        }

        /** Whether the structures were read and not computed. Read it when no step is left. */
        public function get usesStoredStructures():Boolean
        {
            return _structures != null && hasAllStructures;
        }

        /**
         * Makes a cooked file of the model, including the surface. Call it when no step is left. A surface that is missing is prepared now.
         *
         * @param wanted the fingerprint of the model's arguments
         */
        public function toCooked(wanted:Fingerprint):ByteArray
        {
            if (hierarchy != null)
            {
                hierarchy.finished.prepare();
            }
            return fits.toFile(_settings, wanted, CookedShape.of(_model));
        }

        private function get isComplete():Boolean
        {
            return (_structures == null || hasAllStructures) && (hierarchy == null || _fits.hasHierarchy)
                && (!_settings.wantsSurface || _model.triangles == null || _fits.hasSurface);
        }

        private function get hasAllStructures():Boolean
        {
            return _fits.hasStructures && (_fits.hasHull || !_structures.wantsHull);
        }

        private function useFits():void
        {
            if (usesStoredStructures)
            {
                _structures.useStored(_fits.structures, _fits.hull);
            }
            if (hierarchy != null && _fits.hasHierarchy)
            {
                hierarchy.useStored(new TreeReader(_fits.tree, hierarchy.hierarchy.tree, hierarchy.maxDepth), _fits.surface);
            }
        }

        // A hierarchy that was read is not built until it is needed, unless prepareExact is set.
        private function divide():Steps
        {
            return hierarchy.isStored && !_settings.wantsSurface ? null : hierarchy;
        }

        private function keep():void
        {
            if ((!isComplete || hierarchy != null && !hierarchy.isStored) && _store.mayHold(_model))
            {
                _store.keep(_geometry, _settings, fits);
            }
        }

        private function get fits():ModelFits
        {
            return ModelFits.of(structures, hierarchy == null ? null : hierarchy.finished);
        }
    }
}
