package starlogo.libraries
{
    import starlogo.models.Model;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SolidHierarchyBuilder;

    /**
     * The data under the name of one shape.
     *
     * @private
     */
    public final class ShapeEntry
    {
        /** The number of models of this name that are loading. */
        public var loading:int = 0;

        private var _table:ShapeTable;
        private var _revision:int = 0;
        private var _model:Model = null;
        private var _structures:ShapeStructures = null;
        private var _builder:SolidHierarchyBuilder = null;
        private var _hierarchy:SolidHierarchy = null;

        /** @param table counts replaced and removed data of all shapes */
        public function ShapeEntry(table:ShapeTable)
        {
            _table = table;
        }

        /** The number of times that data under this name was replaced or removed. */
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

        /** The structures; null if there are none. */
        public function get structures():ShapeStructures
        {
            return _structures;
        }

        public function set structures(value:ShapeStructures):void
        {
            countChange(_structures);
            _structures = value;
        }

        /** Whether there is a hierarchy. It may not be built yet. */
        public function get hasHierarchy():Boolean
        {
            return _builder != null || _hierarchy != null;
        }

        /** The hierarchy; null if there is none. If it is not built yet, it is built now. */
        public function get hierarchy():SolidHierarchy
        {
            if (_builder != null)
            {
                _hierarchy = _builder.finished;
                _builder = null;
            }
            return _hierarchy;
        }

        /** Sets the builder that has the hierarchy, or that builds it when it is first needed; null for none. */
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
