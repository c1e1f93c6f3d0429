package docs
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.collision.Contact;

    /** For docs/queries.md: a bear that goes until it touches, and along what it touches. */
    public class QueriesPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var contact:Contact = new Contact();

        protected function splash(point:Vector3D):void
        {
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertTrue(bear.x > 0 && bear.y > 0);
        }
    }
}
