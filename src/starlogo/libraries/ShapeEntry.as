package starlogo.libraries
{
    import starlogo.models.Model;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SolidHierarchyBuilder;

    /**
     * What is known under the name of one shape.
     *
     * @private
     */
    public final class ShapeEntry
    {
        /** How many models of the name are being loaded. */
        public var loading:int = 0;

        private var _table:ShapeTable;
        private var _revision:int = 0;
        private var _model:Model = null;
        private var _structures:ShapeStructures = null;
        private var _builder:SolidHierarchyBuilder = null;
        private var _hierarchy:SolidHierarchy = null;

        /**
         * @param table counts what is replaced or removed
         */
        public function ShapeEntry(table:ShapeTable)
        {
            _table = table;
        }

        /** How often something that was known under the name was replaced or removed. */
        public function get revision():int
        {
            return _revision;
        }

        /** The model; null if none was added. */
        public function get model():Model
        {
            return _model;
        }

        public function set model(value:Model):void
        {
            countChange(_model);
            _model = value;
        }

        /** Its structures; null if there are none. */
        public function get structures():ShapeStructures
        {
            return _structures;
        }

        public function set structures(value:ShapeStructures):void
        {
            countChange(_structures);
            _structures = value;
        }

        /** Whether there is a hierarchy, built or not. */
        public function get hasHierarchy():Boolean
        {
            return _builder != null || _hierarchy != null;
        }

        /** Its hierarchy, built now where that was left until it is needed; null if there is none. */
        public function get hierarchy():SolidHierarchy
        {
            if (_builder != null)
            {
                _hierarchy = _builder.finished;
                _builder = null;
            }
            return _hierarchy;
        }

        /** Sets the builder that has the hierarchy, or builds it when it is first asked for; null for none. */
        public function setHierarchy(builder:SolidHierarchyBuilder):void
        {
            countChange(_builder || _hierarchy);
            _builder = builder == null || builder.isDone ? null : builder;
            _hierarchy = builder == null || !builder.isDone ? null : builder.hierarchy;
        }

        private function countChange(before:Object):void
        {
            if (before != null)
            {
                _revision++;
                _table.revision++;
            }
        }
    }
}
