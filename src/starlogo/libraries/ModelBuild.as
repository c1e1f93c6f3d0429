package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.GeometryFingerprint;
    import starlogo.libraries.cooked.FitsReader;
    import starlogo.libraries.cooked.FitsWriter;
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
    public final class ModelBuild implements Steps
    {
        private var _model:Model;
        private var _structures:StructuresBuild;
        private var _hierarchy:SolidHierarchyBuilder;
        private var _settings:FitSettings;
        private var _store:FitStore;
        private var _geometry:GeometryFingerprint;
        private var _fits:ModelFits = new ModelFits();
        private var _work:StepSequence = new StepSequence();

        /**
         * @param model the model
         * @param structures finds its structures; null if none are wanted
         * @param hierarchy builds its hierarchy; null if none is wanted
         * @param settings the settings of the libraries that want them
         * @param store null for none
         */
        public function ModelBuild(model:Model, structures:StructuresBuild, hierarchy:SolidHierarchyBuilder, settings:FitSettings,
                store:FitStore)
        {
            _model = model;
            _structures = structures;
            _hierarchy = hierarchy;
            _settings = settings;
            if (model.cooked != null)
            {
                FitsReader.read(model.cooked, model, settings, _fits);
            }
            _store = isComplete ? null : store;
            if (_store != null)
            {
                _geometry = store.geometryOf(model, settings);
                _work.add(store.reading(model, _geometry, settings, _fits));
            }
            _work.call(useFits);
            if (structures != null)
            {
                _work.add(structures);
            }
            if (hierarchy != null)
            {
                _work.begin(divide);
            }
            if (_store != null)
            {
                _work.call(keep);
            }
        }

        /** The structures, when no step is left; null if none were wanted. */
        public function get structures():ShapeStructures
        {
            return _structures == null ? null : _structures.structures;
        }

        /** Whether the structures were read and not computed. Read it when no step is left. */
        public function get areStructuresRead():Boolean
        {
            return _structures != null && _fits.structures != null;
        }

        /** The builder that has the hierarchy or builds it when it is needed. Read it when no step is left. Null if none was wanted. */
        public function get hierarchy():SolidHierarchyBuilder
        {
            return _hierarchy;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        /**
         * Makes a cooked file of the model, including the surface. Call it when no step is left. A surface that is missing is prepared now.
         *
         * @param wanted the fingerprint of the model's arguments
         */
        public function toCooked(wanted:Fingerprint):ByteArray
        {
            if (_hierarchy != null)
            {
                _hierarchy.finished.prepare();
            }
            return FitsWriter.write(fits, _settings, wanted, CookedShape.of(_model));
        }

        private function get isComplete():Boolean
        {
            return (_structures == null || _fits.structures != null) && (_hierarchy == null || _fits.tree != null)
                && (!wantsSurface || _fits.surface != null);
        }

        private function useFits():void
        {
            if (_structures != null && _fits.structures != null)
            {
                _structures.useRead(_fits.structures);
            }
            if (_hierarchy != null && _fits.tree != null)
            {
                _hierarchy.useStored(new TreeReader(_fits.tree), _fits.surface);
            }
        }

        // A hierarchy that was read is not built until it is needed, unless prepareExact is set.
        private function divide():Steps
        {
            return _hierarchy.isTaken && !_settings.wantsSurface ? null : _hierarchy;
        }

        private function keep():void
        {
            if ((!isComplete || _hierarchy != null && !_hierarchy.isTaken) && _store.mayHold(_model))
            {
                _store.keep(_geometry.fingerprint, _settings, fits);
            }
        }

        private function get fits():ModelFits
        {
            return ModelFits.of(structures, _hierarchy == null ? null : _hierarchy.finished);
        }

        private function get wantsSurface():Boolean
        {
            return _settings.wantsSurface && _model.triangles != null;
        }
    }
}
