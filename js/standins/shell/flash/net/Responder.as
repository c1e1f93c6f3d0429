package flash.net
{
    /** Is never told of anything. */
    public class Responder
    {
        public function Responder(result:Function, status:Function = null)
        {
        }
    }
}
