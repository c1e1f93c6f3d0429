package starlogo
{
    import starlogo.hierarchy.HierarchyBuilder;
    import starlogo.libraries.StructuresBuild;
    import starlogo.models.Model;
    import starlogo.steps.Steps;

    /** A model on its way into a GreatLand: all is built first, and stored in the last step. */
    internal final class ModelIntake implements Steps
    {
        private var _greatLand:GreatLand;
        private var _model:Model;
        private var _hierarchy:HierarchyBuilder;
        private var _structures:StructuresBuild;
        private var _left:Vector.<Steps> = new Vector.<Steps>();

        /**
         * @param greatLand where it goes
         * @param model the model
         * @param hierarchy builds its hierarchy; null for none
         * @param structures finds its structures; null for none
         */
        public function ModelIntake(greatLand:GreatLand, model:Model, hierarchy:HierarchyBuilder, structures:StructuresBuild)
        {
            _greatLand = greatLand;
            _model = model;
            _hierarchy = hierarchy;
            _structures = structures;
            if (structures != null)
            {
                _left.push(structures);
            }
            if (hierarchy != null)
            {
                _left.push(hierarchy);
            }
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var last:int = _left.length - 1;
            if (last < 0)
            {
                _greatLand.store(_model, _hierarchy == null ? null : _hierarchy.hierarchy,
                        _structures == null ? null : _structures.structures);
                return false;
            }
            if (!_left[last].step())
            {
                _left.pop();
            }
            return true;
        }
    }
}
